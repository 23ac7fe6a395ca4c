#include "solve_all.h"
#include "tb_tension.h"

void solve_all(size_t count, const double structure[], const double wrench[], double tension[],
               int solved[])
{
    for (size_t i = 0; i < count; i++) {
        double delivered[DOF];
        double kkt_residual[1];
        tb_status const status =
            tb_distribute_tension(&structure[i * DOF * CABLES], &wrench[i * DOF],
                                  &tension[i * CABLES], delivered, kkt_residual);
        solved[i] = status == TB_OK;
    }
}
