// SPDX-License-Identifier: MIT
/// @file
/// A file of registers for the benchmarks that write them.
#pragma once

#include "base/unique_fd.hpp"
#include "protocol/registers.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

namespace raymarch::bench
{

/// A file of one register page, with a name for as long as this lives: registers whose name has
/// gone are taken for lost. Whoever maps it is the only one that may. Ends the program where there
/// can be no such file.
struct RegisterPage
{
    std::string path = (std::filesystem::temp_directory_path() / "raymarch-bench-XXXXXX").string();
    UniqueFd fd = UniqueFd(::mkstemp(path.data()));
    RegisterPage()
    {
        if (fd && ::ftruncate(fd.get(), protocol::register_page_bytes) == 0)
            return;
        std::cerr << "no register page at " << path << '\n';
        std::exit(EXIT_FAILURE);
    }
    RegisterPage(const RegisterPage&) = delete;
    RegisterPage& operator=(const RegisterPage&) = delete;
    ~RegisterPage() { ::unlink(path.c_str()); }
};

} // namespace raymarch::bench
