// SPDX-License-Identifier: MIT
/// @file
/// The documents that are made from the tables, as text.
#pragma once

#include <string>

namespace raymarch::tools
{

[[nodiscard]] std::string registers_page();        ///< docs/registers.md
[[nodiscard]] std::string parameters_section();    ///< of docs/protocol.md
[[nodiscard]] std::string commands_section();      ///< of docs/protocol.md
[[nodiscard]] std::string errors_section();        ///< of docs/protocol.md
[[nodiscard]] std::string presets_section();       ///< of docs/protocol.md
[[nodiscard]] std::string status_section();        ///< of docs/protocol.md
[[nodiscard]] std::string settings_file();         ///< systemd/raymarchd.toml
[[nodiscard]] std::string actions_table();         ///< of docs/gpio.md
[[nodiscard]] std::string actions_manual();        ///< of docs/man/raymarchd.8
[[nodiscard]] std::string systemverilog_package(); ///< overlay/rtl/raymarch_registers_pkg.sv

} // namespace raymarch::tools
