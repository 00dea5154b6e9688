// A part of one colour.
void pass_on_color() {}
