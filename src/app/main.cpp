#include "app/commands/commands.h"
#include "app/terminal/process.h"

int main(int argc, char** argv) try {
  twrench::app::prepare_process();
  return static_cast<int>(twrench::app::run(argc, argv));
} catch (...) {  // there is not enough memory to report it
  twrench::app::end_at_once();
}
