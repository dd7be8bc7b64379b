/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "claims.h"
#include "rwedge.h"

CLAIM(every_status_has_a_text)
{
    for (int32_t status = RWEDGE_OK; status <= RWEDGE_EPATH; status++)
        assert_string_not_equal(rwedge_strerror(status), "unknown status");
    assert_string_equal(rwedge_strerror(RWEDGE_EPATH + 1), "unknown status");
    assert_string_equal(rwedge_strerror(INT32_MIN), "unknown status");
}

CLAIM(the_version_is_that_of_the_header)
{
    assert_string_equal(rwedge_version(), RWEDGE_VERSION);
}
