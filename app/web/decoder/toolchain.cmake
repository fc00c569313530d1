# SPDX-License-Identifier: GPL-3.0-or-later
# WebAssembly by Debian's Clang and wasi-libc: packages clang-14, lld-14, wasi-libc, libc++-14-dev-wasm32,
# libclang-rt-14-dev-wasm32.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_CXX_COMPILER clang++-14)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_EXECUTABLE_SUFFIX_CXX .wasm)
# Optimisation is for the compiler alone: Clang 14 that links with it calls wasm-opt where there is one, which knows no
# SIMD.
set(CMAKE_CXX_FLAGS_RELEASE "")
