// The layouts with the library's own flags. tests/library/consumer.cpp includes the same header
// and is compiled with others.
#include "library/layout.h"
