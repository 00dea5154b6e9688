// Checks the layouts with the library's own flags. tests/library/consumer.cpp includes the same
// header and is compiled with other flags.
#include "library/layout.h"
