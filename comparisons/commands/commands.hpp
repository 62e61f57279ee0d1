#pragma once

#include <string_view>

#include "comparisons/command_line/command.hpp"
#include "comparisons/command_line/declarations.hpp"

namespace springcheck {

// The commands that read, compute or write, each in the file of its name.
Command run_command();
Command table_command();
Command reproduce_command();
Command sweep_command();
Command stability_command();
Command chart_command();
Command advise_command();
Command gate_command();
Command report_command();
Command export_command();
Command merge_command();
Command measure_command();
Command mesh_command();
Command schema_command();

/// The commands in the order in which help tells them.
inline constexpr Command (*every_command[])() = {
    run_command,       table_command,   reproduce_command, sweep_command,  chart_command,
    stability_command, advise_command,  gate_command,      report_command, export_command,
    merge_command,     measure_command, mesh_command,      schema_command};

/// The texts of the commands, and the lists of the names that they take.
Declarations declarations();

/// The command of that name. Throws InputError for another name, with the nearest.
Command command_named(std::string_view name);

}  // namespace springcheck
