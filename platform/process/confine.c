#include "platform/process/confine.h"

#include "platform/process/confine_calls.h"
#include "platform/process/confine_files.h"

#include <errno.h>
#include <string.h>
#include <sys/prctl.h>

/* Whether the kernel enforces it; error is 0 or -errno. */
static bool is_held(const struct log *log, const char *what, int error)
{
	if (error == -ENOSYS || error == -EOPNOTSUPP) {
		/* Not counted: a kernel without one of them. */
		log_note(log, "confinement: this kernel has no %s", what);
	} else if (error) {
		log_warning(log, "confinement: limber runs without %s: %s",
			what, strerror(-error));
	}
	return error == 0;
}

struct confinement confine_process(
	const struct confine_request *request, const struct log *log)
{
	struct confinement held;
	int calls = -ENOSYS, files = -ENOSYS;

	/* seccomp and Landlock require it. It also disables set-user-id programs. */
	if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) {
		files = request->writes_anywhere
			? 0
			: confine_files(request->output);
		calls = confine_calls(request->connects);
	}
	held.calls = is_held(log, "seccomp", calls);
	held.files = is_held(log, "Landlock", files);
	return held;
}
