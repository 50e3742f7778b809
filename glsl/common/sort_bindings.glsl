// Binding points of the arrays of a radix sort pass.
#ifndef SORT_BINDINGS
#define SORT_BINDINGS

const int recordsBinding = 0;
const int nextRecordsBinding = 1;
const int digitsBinding = 2;

#endif
