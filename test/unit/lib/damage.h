/* damage.h - a result damaged by chance, and what the routines do with it that
 * read arrays which no call may have made.
 *
 * damage - n points, their verified result and its iw.  Numbers of the result,
 * of an unfinished one, or of neither are changed.  Then tess_resume must end
 * with a code and after a negative one leave its arrays as they were; tess_check
 * must not prove what is wrong; tess_check, tess_hull and tess_locate, which may
 * rely on tet alone, must end.  None may touch what is outside of its arrays,
 * which have their very lengths.  draw(m) gives one of 0 ... m-1, m <= 65536.
 * Returns what is wrong, or NULL.
 *
 * damage_resume - tess_resume alone, of ntet tetrahedra as they are. */
#ifndef DAMAGE_H
#define DAMAGE_H

#include "../../../tess.h"

const char *damage(tess_int n, const tess_real *p, tess_int ntet,
                   const tess_int *tet, const tess_int *adj,
                   const tess_int *iw, int (*draw)(int));
const char *damage_resume(tess_int n, const tess_real *p, tess_int ntet,
                          const tess_int *tet, const tess_int *adj,
                          int (*draw)(int));

#endif
