// A body whose shape shows its rotation.
void pass_on_mark(vec4 place) {}
