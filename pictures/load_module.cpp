// SPDX-License-Identifier: MIT
#include "pictures/load_module.hpp"

#include <dlfcn.h>

namespace raymarch::pictures
{

void* find_in_module(const char* file, const char* symbol)
{
    // Never closed; for a module that is loaded, dlopen only looks it up.
    void* const module = ::dlopen(file, RTLD_NOW | RTLD_LOCAL);
    return module == nullptr ? nullptr : ::dlsym(module, symbol);
}

} // namespace raymarch::pictures
