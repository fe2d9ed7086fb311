#include "command_line/command_line.h"

int main(int argc, char** argv) { return pliant::viewer::run_command_line(argc, argv); }
