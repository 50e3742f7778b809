// Binding points of the arrays of a radix sort pass. Compiles as GLSL and as C++ (src/gl/radix_sort.cpp).
#ifndef SORT_BINDINGS
#define SORT_BINDINGS

const int recordsBinding = 0;
const int nextRecordsBinding = 1;
const int digitsBinding = 2;

#endif
