// A part that has no other near it.
void pass_on_neighbours() {}
