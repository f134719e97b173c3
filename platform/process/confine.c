#include "platform/process/confine.h"

#include "platform/process/confine_calls.h"
#include "platform/process/confine_files.h"

#include <sys/prctl.h>

struct confinement confine_process(
	const struct confine_request *request, const struct log *log)
{
	struct confinement held = {false, false};

	/* seccomp and Landlock require it. It also disables set-user-id programs. */
	if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0) {
		held.files = request->writes_anywhere ||
			confine_files(request->output) == 0;
		held.calls = confine_calls(request->connects) == 0;
	}
	if (!held.calls || !held.files) {
		/* Not counted: a kernel without one of them. */
		log_note(log, "confinement: this kernel has no %s%s%s",
			held.calls ? "" : "seccomp",
			held.calls || held.files ? "" : " and no ",
			held.files ? "" : "Landlock");
	}
	return held;
}
