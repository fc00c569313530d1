// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/model/haptics/interposed.h"

#include <cerrno>
#include <cstddef>

#include <dlfcn.h>
#include <pthread.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define SANDREEL_SANITIZED 1
#else
#define SANDREEL_SANITIZED 0
#endif

namespace {

thread_local constinit tests::Interposed calls;

} // namespace

const tests::Interposed &tests::interposedCalls()
{
    return calls;
}

#if SANDREEL_SANITIZED

extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*)(const volatile void *, std::size_t),
                                                         void (*)(const volatile void *));
namespace {

[[maybe_unused]] const int hooks = __sanitizer_install_malloc_and_free_hooks(
    [](const volatile void *, std::size_t) { ++calls.allocations; }, [](const volatile void *) { ++calls.releases; });

} // namespace

#else

// operator new ends here too.
extern "C" {
void *__libc_malloc(std::size_t);
void *__libc_calloc(std::size_t, std::size_t);
void *__libc_realloc(void *, std::size_t);
void __libc_free(void *);

void *malloc(std::size_t size) noexcept
{
    ++calls.allocations;
    return __libc_malloc(size);
}
void *calloc(std::size_t count, std::size_t size) noexcept
{
    ++calls.allocations;
    return __libc_calloc(count, size);
}
void *realloc(void *memory, std::size_t size) noexcept
{
    ++calls.allocations;
    return __libc_realloc(memory, size);
}
void free(void *memory) noexcept
{
    calls.releases += memory != nullptr;
    __libc_free(memory);
}
}

#endif

#if !defined(__SANITIZE_THREAD__) // which has a stand-in of its own

extern "C" int pthread_mutex_lock(pthread_mutex_t *mutex) noexcept
{
    using Lock = int (*)(pthread_mutex_t *);
    static constinit Lock real = nullptr; // no guard: its lock would be this one
    if (!real)
        real = reinterpret_cast<Lock>(dlsym(RTLD_NEXT, "pthread_mutex_lock"));
    ++calls.locks;
    return real(mutex);
}

#endif
