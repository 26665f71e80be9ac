// SPDX-License-Identifier: MIT
/// @file
/// Writes the documents that are made from the tables, or reports which of them are stale.
#include "drivers/atomic_file.hpp"
#include "tools/generated.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <sysexits.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace
{

namespace fs = std::filesystem;
namespace drivers = raymarch::drivers;
namespace tools = raymarch::tools;

/// One generated text: a whole file, or the text between two markers in a file.
struct Document
{
    const char* path;
    const char* section; ///< empty for a whole file
    std::string (*make)();
};

const std::vector<Document> documents = {
    {"docs/registers.md", "", tools::registers_page},
    {"docs/protocol.md", "parameters", tools::parameters_section},
    {"docs/protocol.md", "commands", tools::commands_section},
    {"docs/protocol.md", "errors", tools::errors_section},
    {"docs/protocol.md", "presets", tools::presets_section},
    {"docs/protocol.md", "status", tools::status_section},
    {"docs/gpio.md", "actions", tools::actions_table},
    {"docs/man/raymarchd.8", "actions", tools::actions_manual},
    {"systemd/raymarchd.toml", "", tools::settings_file},
    {"overlay/rtl/raymarch_registers_pkg.sv", "", tools::systemverilog_package},
};

std::string read(const fs::path& path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

/// Returns `present` with the new text of the document, or an empty string if its markers are
/// missing.
std::string updated(const Document& document, const std::string& present)
{
    const std::string_view section = document.section;
    if (section.empty())
        return document.make();
    const bool manual = !std::string_view(document.path).ends_with(".md");
    const auto marker = [&](const char* which) {
        return manual ? fmt::format(".\\\" {} {}\n", which, section)
                      : fmt::format("<!-- {} {} -->\n", which, section);
    };
    const std::string begin = marker("begin");
    const std::string end = marker("end");
    const std::size_t from = present.find(begin);
    const std::size_t to = present.find(end);
    if (from == std::string::npos || to == std::string::npos)
        return {};
    return present.substr(0, from + begin.size()) + document.make() + present.substr(to);
}

} // namespace

int main(int argc, char** argv)
{
    CLI::App app("Writes the documents that are made from the tables", "dump_tables");
    fs::path root;
    bool check = false;
    bool write = false;
    app.add_flag("--check", check, "report stale documents; the exit status is 1 if there are any");
    app.add_flag("--write", write, "write the documents")->excludes("--check");
    app.add_option("ROOT", root, "root folder of the repository")->required();
    CLI11_PARSE(app, argc, argv);

    bool stale = false;
    for (const Document& document : documents) {
        const fs::path path = root / document.path;
        const std::string present = read(path);
        const std::string wanted = updated(document, present);
        if (wanted == present && !wanted.empty())
            continue;
        if (wanted.empty() || !write) {
            fmt::print("{}{}{}: {}\n", document.path, *document.section != '\0' ? ", " : "",
                       document.section,
                       wanted.empty() ? "the markers of this section are missing"
                                      : "stale; ./dev docs writes it again");
            stale = true;
            continue;
        }
        fs::create_directories(path.parent_path());
        if (const auto written = drivers::replace_file(path, drivers::as_bytes(wanted),
                                                       drivers::Durability::BestEffort);
            !written) {
            fmt::print(stderr, "dump_tables: {}\n", written.error().message);
            return EX_IOERR;
        }
        fmt::print("{}: written\n", document.path);
    }
    return stale ? 1 : 0;
}
