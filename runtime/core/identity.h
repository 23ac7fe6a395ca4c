/* What a program is: the text stands in the program's file, where `turnbuckle info` finds it without
 * running the program. */
#ifndef TB_IDENTITY_H
#define TB_IDENTITY_H

#ifdef __cplusplus
extern "C" {
#endif

#define TB_IDENTITY_MARK "@(#)turnbuckle " /* what the text begins with, as what(1) finds it */

/** The mark, then machine and its hash, precision, version and processor. */
extern const char tb_identity[];

/** The text without its mark. */
#define TB_IDENTITY_TEXT (tb_identity + sizeof TB_IDENTITY_MARK - 1u)

#ifdef __cplusplus
}
#endif

#endif
