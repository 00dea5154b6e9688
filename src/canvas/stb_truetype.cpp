// A font that breaks an assumption draws wrong; it does not end the program.
#define STBTT_assert(condition) static_cast<void>(condition)
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>
