/*
 * The looks of a crowd's walkers: shirts, trousers, shoes and hair.
 */
#ifndef APP_DEMO_CROWD_CROWD_DRESS_H
#define APP_DEMO_CROWD_CROWD_DRESS_H

#include "app/scene/instance/instance.h"

/*
 * Gives an instance the look of a walker, number 0, 1 and so on. There are
 * twelve looks, which repeat; the first one is the model's own. Looks are
 * clothes for a model made as the walker is: with a material named "shirt",
 * with colours at the vertices of all that has no texture, and with no texture
 * but the shirt's and those that have a normal map. For any other model they
 * are a tint. For shirts without stripes, the instance gets a changed copy of
 * its model, in its arena. Returns 0 or -ENOMEM.
 */
int crowd_dress(struct instance *instance, int number);

#endif
