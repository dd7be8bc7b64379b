/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "rwedge.h"

static void every_status_has_a_text(void **state)
{
    for (int32_t status = RWEDGE_OK; status <= RWEDGE_EPATH; status++)
        assert_string_not_equal(rwedge_strerror(status), "unknown status");
    assert_string_equal(rwedge_strerror(RWEDGE_EPATH + 1), "unknown status");
    assert_string_equal(rwedge_strerror(INT32_MIN), "unknown status");
}

static void the_version_is_that_of_the_header(void **state)
{
    assert_string_equal(rwedge_version(), RWEDGE_VERSION);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_status_has_a_text),
        cmocka_unit_test(the_version_is_that_of_the_header),
    };
    return RUN_CLAIMS("status", tests);
}
