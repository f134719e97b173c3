#include "trace/trace-hw_arm_imx31_pdk.h"
