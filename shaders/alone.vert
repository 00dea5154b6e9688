// A part without occluders.
void pass_on_neighbours() {}
