// SPDX-License-Identifier: GPL-3.0-or-later
// There are no exceptions in WebAssembly as Debian's Clang makes it. What would be thrown here is std::bad_alloc, or
// std::length_error for an array that is longer than memory: both are the end of this instance.
#include "app/web/decoder/outofmemory.h"

#include <cstddef>

extern "C" {

void *__cxa_allocate_exception(std::size_t)
{
    web::outOfMemory();
}

[[noreturn]] void __cxa_throw(void *, void *, void (*)(void *))
{
    web::outOfMemory();
}

} // extern "C"
