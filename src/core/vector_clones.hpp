// Inner loops in two versions, chosen when the program starts: for any processor, and for those with AVX2.
#pragma once

/// Before a function whose loops the compiler turns into vector instructions; what it calls in the same file
/// is made part of it. Integers give the same results in both versions. Left out where the loader cannot
/// choose: other compilers and processors, and instrumented builds, which run before their runtime is ready.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define RVA_VECTOR_CLONES __attribute__((target_clones("avx2", "default"), flatten))
#else
#define RVA_VECTOR_CLONES
#endif
