#include "platform/display/kms/kms_calls.h"

#include <poll.h>

static int system_wait(int fd, int timeout_ms)
{
	struct pollfd entry = {.fd = fd, .events = POLLIN};

	return poll(&entry, 1, timeout_ms);
}

const struct kms_calls kms_calls_system = {
	.device = &device_calls_system,
	.get_cap = drmGetCap,
	.is_master = drmIsMaster,
	.set_master = drmSetMaster,
	.drop_master = drmDropMaster,
	.get_resources = drmModeGetResources,
	.free_resources = drmModeFreeResources,
	.get_connector = drmModeGetConnectorCurrent,
	.probe_connector = drmModeGetConnector,
	.free_connector = drmModeFreeConnector,
	.get_encoder = drmModeGetEncoder,
	.free_encoder = drmModeFreeEncoder,
	.get_crtc = drmModeGetCrtc,
	.free_crtc = drmModeFreeCrtc,
	.set_crtc = drmModeSetCrtc,
	.create_dumb = drmModeCreateDumbBuffer,
	.map_dumb = drmModeMapDumbBuffer,
	.destroy_dumb = drmModeDestroyDumbBuffer,
	.add_fb = drmModeAddFB2,
	.remove_fb = drmModeRmFB,
	.page_flip = drmModePageFlip,
	.dirty_fb = drmModeDirtyFB,
	.wait = system_wait,
	.handle_event = drmHandleEvent,
};
