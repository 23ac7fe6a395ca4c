#include "solve_all.h"
#include "tb_comparison.h"

void solve_all(size_t count, const double structure[], const double wrench[], double tension[],
               int solved[])
{
    for (size_t i = 0; i < count; i++) {
        tb_status const status = tb_reduced_matrix_tension(&structure[i * DOF * CABLES],
                                                           &wrench[i * DOF], &tension[i * CABLES]);
        solved[i] = status == TB_OK;
    }
}
