/* CasADi writes the double names of the mathematics; this makes them single precision. */
#include <math.h>

#define sqrt sqrtf
#define fabs fabsf
#define fmin fminf
#define fmax fmaxf
#define pow powf
