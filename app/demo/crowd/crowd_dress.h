/*
 * The looks of a crowd's walkers: shirts, trousers, shoes and hair.
 */
#ifndef APP_DEMO_CROWD_CROWD_DRESS_H
#define APP_DEMO_CROWD_CROWD_DRESS_H

#include "app/scene/instance/instance.h"

/*
 * Gives an instance the look of walker number 0, 1 and so on; twelve looks
 * repeat, the first of which is the model's own. Some shirts lose their
 * stripes, for which the instance gets a model of its own, in its arena. The
 * clothes are those of a model with a material named "shirt"; any other model
 * gets a tint. 0 or -ENOMEM.
 */
int crowd_dress(struct instance *instance, int number);

#endif
