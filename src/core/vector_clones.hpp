// Inner loops in two versions, chosen when the program starts: for any processor, and for those with AVX2.
#pragma once

/// To be put before a function whose loops the compiler vectorises; functions of the same file that it calls
/// are inlined. Integer results are the same in both versions. Has no effect where the loader cannot choose
/// between versions: with other compilers and processors, and in instrumented builds, in which the choice
/// would run before the instrumentation's runtime is ready.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
#define RVA_VECTOR_CLONES __attribute__((target_clones("avx2", "default"), flatten))
#else
#define RVA_VECTOR_CLONES
#endif
