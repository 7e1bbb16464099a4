// The commands of glint-measure, which `glint` runs as its own (commands/measuring_program.h).
#pragma once

namespace glint {

class Command;

void addStressCommand(const Command& program);
void addBenchCommand(const Command& program);

void addMeasuringCommands(const Command& program);

}  // namespace glint
