#pragma once

// LAPACK, whose complex numbers are those of the standard library here.

#include <complex>

#define lapack_complex_float std::complex<float>
#define lapack_complex_double std::complex<double>
#include <lapacke.h>
