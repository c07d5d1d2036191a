// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Locks.h"

#include <dlfcn.h>
#include <pthread.h>

namespace {
thread_local long g_locks = 0;
}  // namespace

// Every std::mutex, every contended QMutex and every lock of a library calls these functions, because the program's own
// symbols take precedence over those of libc.
#ifndef CUSP_SANITIZED
namespace {
template <class Function>
Function next(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}
}  // namespace

extern "C" {
int pthread_mutex_lock(pthread_mutex_t* mutex) noexcept
{
    static const auto real = next<int (*)(pthread_mutex_t*)>("pthread_mutex_lock");
    ++g_locks;
    return real(mutex);
}
int pthread_mutex_trylock(pthread_mutex_t* mutex) noexcept
{
    static const auto real = next<int (*)(pthread_mutex_t*)>("pthread_mutex_trylock");
    ++g_locks;
    return real(mutex);
}
int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex)
{
    static const auto real = next<int (*)(pthread_cond_t*, pthread_mutex_t*)>("pthread_cond_wait");
    ++g_locks;
    return real(condition, mutex);
}
}
#endif

long support::locksOnThisThread()
{
    return g_locks;
}
