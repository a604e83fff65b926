#pragma once

#include "breccia/viscoelasticity/prony_series.hpp"

namespace breccia {

/// The relaxation modulus of plasticised Estane, as in data/pbx9501_binder_prony.csv.
inline const PronySeries binder(0.0, {{1.5e+07, 4168.7},     {1.5e+06, 7413.1},     {1.5e+05, 15849},
                                      {1.5e+04, 38019},      {1.5e+03, 67608},      {1.5e+02, 89125},
                                      {1.5e+01, 1.1561e+05}, {1.5e+00, 1.4223e+05}, {1.5e-01, 1.6218e+05},
                                      {1.5e-02, 2.2182e+05}, {1.5e-03, 4.7534e+05}, {1.5e-04, 2.6182e+06},
                                      {1.5e-05, 1.2882e+07}, {1.5e-06, 5.2481e+07}, {1.5e-07, 2.2387e+08},
                                      {1.5e-08, 4.3652e+08}, {1.5e-09, 4.5709e+08}, {1.5e-10, 3.4674e+08},
                                      {1.5e-11, 2.5119e+08}, {1.5e-12, 1.7783e+08}, {1.5e-13, 1.1749e+08},
                                      {1.5e-14, 7.5858e+07}});

}  // namespace breccia
