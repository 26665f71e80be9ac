// SPDX-License-Identifier: MIT
/// @file
/// Makes the texts of the documents that come from the tables.
#pragma once

#include <string>

namespace raymarch::tools
{

[[nodiscard]] std::string registers_page();        ///< docs/registers.md
[[nodiscard]] std::string parameters_section();    ///< for docs/protocol.md
[[nodiscard]] std::string commands_section();      ///< for docs/protocol.md
[[nodiscard]] std::string errors_section();        ///< for docs/protocol.md
[[nodiscard]] std::string presets_section();       ///< for docs/protocol.md
[[nodiscard]] std::string status_section();        ///< for docs/protocol.md
[[nodiscard]] std::string settings_file();         ///< systemd/raymarchd.toml
[[nodiscard]] std::string actions_table();         ///< for docs/gpio.md
[[nodiscard]] std::string actions_manual();        ///< for docs/man/raymarchd.8
[[nodiscard]] std::string systemverilog_package(); ///< overlay/rtl/raymarch_registers_pkg.sv

} // namespace raymarch::tools
