// Nothing but whether there is a point.
void main() {}
