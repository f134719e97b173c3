/* Every statement of a character file, right and wrong. */
#include "app/character/sketch/character_sketch.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

struct statement {
	const char *right;
	const char *wrong;
	const char *why; /* part of the error of the wrong one */
};

#define BALL "[target ball]\nplace = 0 1 1\n"

static const struct statement walker[] = {
	{"[character]\n", "[caracter]\n", "no such kind of section"},
	{"[names]\nmove = walk\n[state a]\nclip = move\n",
		"[names]\nmove = wakl\n[state a]\nclip = move\n",
		"no clip named wakl: there are idle, jump, run, walk, wave"},
	{"[parameter a]\nrange = 0 2\n", "[parameter a]\nrange = 2 0\n",
		"second number has to be larger"},
	{"[parameter a]\nstart = 0.5\n", "[parameter a]\nstart = 7\n",
		"outside the range 0 to 1"},
	{"[parameter a]\nease = 0.5\n", "[parameter a]\nease = -1\n",
		"seconds from 0 to 60"},
	{"[parameter a]\nsource = time 0.5 1\n",
		"[parameter a]\nsource = clock\n", "no parameter named clock"},
	{"[parameter a]\nsource = sine 2 0.5\n",
		"[parameter a]\nsource = sine\n", "needs a period"},
	{"[parameter a]\nsource = motion\n",
		"[parameter a]\nsource = motion 3\n", "3 is too much"},
	{"[parameter a]\n[parameter b]\nsource = a 2 1\n",
		"[parameter b]\nsource = a 2 1\n", "no parameter named a"},
	{"[parameter a]\n", "[parameter]\n", "has one name"},
	{"[parameter a]\nstops = 0 0.5 1\n[buttons]\nUP = step a 1\n",
		"[parameter a]\nstops = 0 0.5 0.2\n", "increasing numbers"},
	{"[parameter a]\nchoices = x y\n",
		"[parameter a]\nchoices = x y\nrange = 0 9\n",
		"choices have a range of their own"},
	{"[parameter a]\nlabel = no\n", "[parameter a]\nlabel = none\n",
		"yes or no"},
	{"[parameter a]\nstops = 0 1\n[buttons]\nUP = step a -1\n",
		"[parameter a]\n[buttons]\nUP = step a 1\n",
		"give the parameter stops"},
	{"[state a]\nclip = walk\n", "[state a]\nclip = hop\n",
		"no clip named hop: there are idle, jump, run, walk, wave, rest"},
	{"[state a]\nclip = 0\n", "[state a]\nclip = 9\n", "no clip named 9"},
	{"[state a]\nclip = rest\n", "[state a]\n", "a state plays something"},
	{"[parameter v]\n[state a]\nblend = v, idle 0, walk 0.4, run 1\n",
		"[parameter v]\n[state a]\nblend = v, idle 0\n",
		"at least two clips"},
	{"[parameter v]\n[state a]\nblend = v, run 1, idle 0\n",
		"[parameter v]\n[state a]\nblend = v, run 1, idle 1\n",
		"two clips are at 1"},
	{"[state a]\nclip = walk\nrate = 2\n",
		"[state a]\nclip = walk\nrate = quick\n",
		"no parameter named quick: add a section [parameter quick]"},
	{"[state a]\nclip = walk\nrepeat = ping-pong\n",
		"[state a]\nclip = walk\nrepeat = twice\n",
		"twice is not right here: give loop, once or ping-pong"},
	{"[state a]\nclip = walk\nrepeat = once\npause = 1\nnext = a\n",
		"[state a]\nclip = walk\npause = -1\n",
		"-1 is not right here: give seconds from 0 to 3600"},
	{"[state a]\nclip = walk\nnext = a\n",
		"[state a]\nclip = walk\nnext = b\n",
		"no state named b: there is only a"},
	{"[state a]\nclip = walk\nfade = 60\n",
		"[state a]\nclip = walk\nfade = -1\n", "-1 is not right here"},
	{"[state a]\nclip = walk\nfade = 4 frames linear\n",
		"[state a]\nclip = walk\nfade = 4 frames bouncy\n",
		"bouncy is too much"},
	{"[state a]\nclip = walk\nenter = line hello\n",
		"[state a]\nclip = walk\nenter = shout hello\n",
		"shout is no action"},
	{"[state a]\nclip = walk\nleave = line bye, next\n",
		"[state a]\nclip = walk\nleave = line\n", "write line TEXT"},
	{"[state a]\nclip = walk\n[state b]\nclip = run\n[transition a b]\n",
		"[state a]\nclip = walk\n[transition a b]\n", "no state named b"},
	{"[state a]\nclip = walk\n[transition * a]\npriority = 2\n",
		"[state a]\nclip = walk\n[transition * a]\npriority = high\n",
		"high is not right here"},
	{"[state a]\nclip = walk\n[transition * a]\nexit = 0.8\n",
		"[state a]\nclip = walk\n[transition * a]\nexit = 2\n",
		"fraction of the clip"},
	{"[parameter p]\n[state a]\nclip = walk\n[transition * a]\nwhen = p > 0.5\n",
		"[parameter p]\n[state a]\nclip = walk\n[transition * a]\nwhen = p >= 0.5\n",
		"a comparison is missing"},
	{"[state a]\nclip = walk\n[transition * a]\ninterrupt = never\n",
		"[state a]\nclip = walk\n[transition * a]\ninterrupt = no\n",
		"always, higher or never"},
	{"[state a]\nclip = walk\n[transition * a]\nfade = 0.2 cubic\n",
		"[state a]\nclip = walk\n[transition * a]\nfade = long\n",
		"long is not right here"},
	{"[state a]\nclip = walk\n[transition a a]\n",
		"[state a]\nclip = walk\n[transition a]\n",
		"write [transition FROM TO]"},
	{"[clip walk]\nmarks = 0.1 0.6\n", "[clip walk]\nmarks = 0.6 0.1\n",
		"increasing times within the clip's 1.1 s"},
	{"[clip walk]\nevent = 0.2 line step\n",
		"[clip walk]\nevent = 9 line step\n", "within the clip's 1.1 s"},
	{"[layer a]\nclip = wave\n", "[layer a]\nweight = 1\n",
		"a layer plays a clip"},
	{"[layer a]\nclip = wave\nmask = shoulder.R, head 0.5\n",
		"[layer a]\nclip = wave\nmask = shoulder\n",
		"no node named shoulder: there are shoulder.L, shoulder.R, "},
	{"[layer a]\nclip = wave\nmask = shoulder.R\n",
		"[layer a]\nclip = wave\nmask = shoulder.R,\n",
		"the node's name is missing: there are"},
	{"[layer a]\nclip = wave\nmode = additive\n",
		"[layer a]\nclip = wave\nmode = add\n", "override or additive"},
	{"[layer a]\nclip = wave\nplay = once\n",
		"[layer a]\nclip = wave\nplay = never\n", "loop or once"},
	{"[layer a]\nclip = wave\nnodes = moved\n",
		"[layer a]\nclip = wave\nnodes = some\n", "all or moved"},
	{"[layer a]\nclip = wave\nsoft = 2\n",
		"[layer a]\nclip = wave\nsoft = 1.5\n", "no whole number"},
	{"[layer a]\nclip = wave\nrate = 2\n",
		"[layer a]\nclip = wave\nrate = 200\n", "from -100 to 100"},
	{"[layer a]\nclip = wave\nweight = 0.5\n",
		"[layer a]\nclip = wave\nweight = 5\n", "from 0 to 1"},
	{"[layer a]\nclip = wave\nfade = 0.2\n",
		"[layer a]\nclip = wave\nfade = now\n", "now is not right here"},
	{"[layer a]\nclip = wave\non = no\n",
		"[layer a]\nclip = wave\non = off\n", "yes or no"},
	{"[layer a]\nclip = wave\n[layer b]\nclip = wave\n",
		"[layer a]\nclip = wave\n[shake a]\nbone = head\n",
		"there already is a [layer a]"},
	{"[target a]\nplace = 0 1 2\n", "[target a]\nplace = 0 1\n",
		"a word is missing"},
	{"[target a]\nnode = head\n", "[target a]\nnode = hat\n",
		"no node named hat"},
	{"[target a]\ncamera = yes\n", "[target a]\ncamera = 1\n", "yes or no"},
	{"[target a]\nradius = 0.1\n", "[target a]\nradius = -1\n",
		"metres of the ball"},
	{"[target a]\ncolor = 1 0.5 0\n", "[target a]\ncolor = 255 0 0\n",
		"from 0 to 1"},
	{"[shake a]\nbone = head\nspeed = 40\namplitude = 0.3\n",
		"[shake a]\nspeed = 40\n", "add bone = NODE"},
	{"[shake a]\nbone = head\nattenuation = 0.3\nmodifier = 1\n",
		"[shake a]\nbone = head\nattenuation = 30\n", "from -2 to 2"},
	{"[shake a]\nbone = head\ntranslation = 0 1 0\nrotation = 0 0.1 0\n",
		"[shake a]\nbone = head\nrotation = 0.1\n", "a word is missing"},
	{"[shake a]\nbone = head\nlabel = no\n",
		"[shake a]\nbone = head\npresets = ../presets.ini\n",
		"a file is needed that lies beside this one: give the name of a file"},
	{"[shake a]\nbone = head\n",
		"[shake a]\nbone = head\n[buttons]\nUP = preset a next\n",
		"write preset SHAKE NAME"},
	{"[shake a]\nbone = head\nunit = 0.01\ndelay = 0.1\n",
		"[shake a]\nbone = head\nwobble = 1\n", "no such key"},
	{BALL "[look a]\nbone = neck 0.4\nbone = head\ntarget = ball\n",
		BALL "[look a]\nbone = neck 4\ntarget = ball\n",
		"a share is from 0 to 1"},
	{BALL "[look a]\nbone = neck 0 100\nbone = head 1 0\ntarget = ball\n",
		BALL "[look a]\nbone = neck 0.4 400\ntarget = ball\n",
		"a rate is from 0 to 100"},
	{BALL "[look a]\nbone = head\ntarget = ball\nyaw = 60\npitch = 30\nrate = 4\n",
		BALL "[look a]\nyaw = 60\nbone = head\ntarget = ball\n",
		"name the bones first"},
	{BALL "[look a]\nbone = head\ntarget = ball\nforward = 0 0 1\nup = 0 1 0\n",
		BALL "[look a]\nbone = head\ntarget = ball\nup = 0 0 0\n",
		"must not be 0 0 0"},
	{BALL "[look a]\nbone = head\ntarget = ball\n",
		"[look a]\nbone = head\n", "add target = NAME"},
	{BALL "[reach a]\nlimb = upper_arm.R forearm.R hand.R\ntarget = ball\nshort = 0.1\n",
		BALL
		"[reach a]\nlimb = forearm.R upper_arm.R hand.R\ntarget = ball\n",
		"has to be below"},
	{BALL "[reach a]\nchain = hand.R 4\nlimit = 40\ntarget = ball\n",
		BALL "[reach a]\nchain = hand.R 40\ntarget = ball\n",
		"the number of bones is from 2"},
	{BALL "[reach a]\nlimb = upper_arm.R forearm.R hand.R\npole = 0 -1 0\ntarget = ball\n",
		BALL
		"[reach a]\nlimb = upper_arm.R forearm.R hand.R\nlimit = 4\ntarget = ball\n",
		"only a chain has a limit"},
	{BALL "[reach a]\nlimb = upper_arm.R forearm.R hand.R\ngrip = 0 0.06 0\ntarget = ball\n",
		BALL
		"[reach a]\ngrip = 0 0.06 0\nchain = hand.R 4\ntarget = ball\n",
		"only a limb has a grip"},
	{"[turn a]\nbone = fingers.R\nangle = 40\nfrom = rest\n",
		"[turn a]\nbone = fingers.R\nfrom = now\n", "clip or rest"},
	{"[turn a]\nbone = fingers.R, thumb.R\naxis = 1 0 0\nangle = 60\n",
		"[turn a]\nbone = fingers.R\nangle = 600\n", "from -360 to 360"},
	{"[spring a]\nbones = ponytail.4 4\nfrequency = 2\ndamping = 0.3\n",
		"[spring a]\nfrequency = 2\nbones = ponytail.4 4\n",
		"bones = LAST COUNT as its first line"},
	{"[spring a]\nbones = ponytail.4 4\nbody = hips chest 0.1\nradius = 0.03\n",
		"[spring a]\nbones = ponytail.4 4\nbody = hips chest\n",
		"the radius is a number above 0"},
	{"[spring a]\nbones = ponytail.4 4\nbody = head head 0.1 0 0.1 0\n",
		"[spring a]\nbones = ponytail.4 4\nbody = head head 0.1 0 0.1\n",
		"a word is missing"},
	{"[cape a]\nbone = chest\nshoulders = 0.04 0.06\n",
		"[cape a]\nbone = chest\nshoulders = 0.04\n",
		"a word is missing"},
	{"[spring a]\nbones = ponytail.4 4\ngravity = 0 -9 0\nlimit = 60\n",
		"[spring a]\nbones = ponytail.4 99\n",
		"the number of bones is from 1"},
	{"[breath a]\nbone = chest\nrate = 0.25\nswell = 0.02 0.01 0.05\nlift = 1\n",
		"[breath a]\nrate = 0.25\n", "add bone = NODE"},
	{"[muscle a]\njoint = forearm.L\nbone = upper_arm.L\nfrom = 17\nto = 90\nswell = 0.1 0 0.1\n",
		"[muscle a]\njoint = forearm.L\n", "add joint = NODE and bone"},
	{"[feet a]\nhips = hips\nleft = thigh.L shin.L foot.L\nright = thigh.R shin.R foot.R\n",
		"[feet a]\nhips = hips\nleft = thigh.L shin.L foot.L\nright = thigh.R shin.R foot.R\n"
		"[feet b]\nhips = hips\nleft = thigh.L shin.L foot.L\nright = thigh.R shin.R foot.R\n",
		"its hips carry the feet of [feet a], too"},
	{"[feet a]\nhips = hips\nleft = thigh.L shin.L foot.L\nright = thigh.R shin.R foot.R\n",
		"[feet a]\nhips = hips\nleft = thigh.L shin.L foot.L\n",
		"right = UPPER LOWER TIP"},
	{"[cape a]\nbone = chest\nplace = 0 1.45 -0.12\nwidth = 0.4\nlength = 0.8\n",
		"[cape a]\nwidth = 0.4\n", "bone = NODE and place"},
	{"[cape a]\nbone = chest\nflare = 1.3\npleat = 0.03\nradius = 0.02\ncolor = 0 0 1\nbody = hips chest 0.1\n",
		"[cape a]\nbone = chest\nbody = hips chest 0\n",
		"the radius is a number above 0"},
	{"[output led]\nline = gpiochip0/18\n", "[output led]\n",
		"line = CHIP/LINE"},
	{"[output led]\nline = LED1/active-low\n", "[output led]\nline = 18\n",
		"18 names no line"},
	{"[motion]\nfeet = foot.L foot.R\n", "[motion]\nfeet = foot.L\n",
		"a word is missing"},
	{"[motion]\nroot = hips\n", "[motion]\nroot = hip\n",
		"no node named hip"},
	{"[motion]\nclips = yes\n", "[motion]\nclips = walk\n", "yes or no"},
	{"[parameter v]\n[motion]\nspeed = v\n", "[motion]\nspeed = v\n",
		"no parameter named v"},
	{"[scene]\nzoom = 0.2\n", "[scene]\nzoom = 2\n", "from 0.04 to 1"},
	{"[scene]\nyaw = 20\npitch = 10\nmargin = 1.1\n",
		"[scene]\npitch = 100\n", "degrees from 0 to 89"},
	{"[parameter a]\n[scene]\nshadow = a\nrelief = no\n",
		"[scene]\nrelief = maybe\n", "no parameter named maybe"},
	{"[parameter a]\n[scene]\nwaves = a\n", "[scene]\nwaves = high\n",
		"no parameter named high"},
	{"[scene]\nwaves = 0.1\nshadow = no\n", "[scene]\nwaves = -1\n",
		"metres of uneven ground"},
	{"[scene]\nlabels = right\n", "[scene]\nlabels = top\n",
		"left, right or none"},
	{"[scene]\ntour = 1 UP\ntour = 2 UP\n[buttons]\nUP = pause\n",
		"[scene]\nyaw = 1\nyaw = 2\n",
		"says this already: remove one of both"},
	{"[scene]\nperiod = 4\ntour = 1 UP\ntour = 2 line two, pause\n"
	 "[buttons]\nUP = pause\n",
		"[scene]\ntour = UP\n", "begins with its time"},
	{"[scene]\ntour = 1 UP\n[buttons]\nUP = pause\nUP long = next\n",
		"[scene]\ntour = 1 UP\n[buttons]\nUP = camera turn 9\n",
		"UP does nothing when it is pressed for a moment"},
};

static const struct statement buttons[] = {
	{"UP = next \"the next one\"", "UPP = next", "this is no button"},
	{"UP long = previous", "UP twice = previous",
		"twice is not one of hold, long and release"},
	{"UP = row", "UP = raw", "raw is no action"},
	{"UP = row\nUP long = next", "UP = row\nDOWN = next\nUP = next",
		"says this already: remove one of both"},
	{"UP = row\n[buttons b]\nwhen = v > 0.5\nUP = next",
		"UP = row\n[buttons b]\nUP = next",
		"test.character:14 gives the same buttons something to do"},
	{"UP+DOWN = row\nUP+LEFT = next", "UP+DOWN = row\nDOWN+UP = next",
		"gives the same buttons something to do"},
	{"UP long = row\nUP = next", "UP long = row\nUP  long = next",
		"gives the same buttons something to do"},
	{"DOWN = next\n[buttons b]\nlabel = no\nwhen = v > 0.5\nUP = row",
		"DOWN = next\n[buttons b]\nlabel = never\nUP = row",
		"give yes or no"},
	{"UP release = pause", "F9 release = pause", "limber uses F9"},
	{"F10 = camera turn 60", "F9 = camera turn 60", "limber uses F9"},
	{"UP+DOWN = tour", "UP+UP = tour", "this is no button"},
	{"LEFT+RIGHT = labels", "F9+UP = labels", "limber uses F9"},
	{"UP = set v 1, add v -0.5", "UP = set v", "write set PARAMETER NUMBER"},
	{"UP = toggle v", "UP = toggle w", "no parameter named w"},
	{"UP = toggle wave", "UP = toggle", "write toggle NAME"},
	{"UP = on wave, off wave", "UP = on v",
		"no layer, expression or effect named v"},
	{"UP = go a", "UP = go b", "no state named b"},
	{"UP = play wave", "UP = play a", "no layer named a"},
	{"UP = morph face smile", "UP = morph face grin", "is no key frame"},
	{"UP = morph face next", "UP = morph mouth next", "no morph named mouth"},
	{"UP = pace face 2", "UP = pace face", "write pace MORPH FACTOR"},
	{"UP = curve face", "UP = curve", "write curve MORPH"},
	{"UP = timing face", "UP = timing wave", "no morph named wave"},
	{"UP = move head pitch 1", "UP = move head bank 1",
		"the part has no bank"},
	{"UP = run nod", "UP = run dance", "no sequence named dance"},
	{"UP = stop nod", "UP = stop", "write stop SEQUENCE"},
	{"UP = repeat nod", "UP = repeat", "write repeat SEQUENCE"},
	{"UP = drop head", "UP = drop arm", "no part named arm"},
	{"UP = drop head hand.R", "UP = drop head hat", "no node named hat"},
	{"UP = attach head hand.R 0.3 0 0 0.1",
		"UP = attach head hand.R 0.3 0 0", "write attach PART NODE"},
	{"UP = keys", "UP = keys all", "all is too much"},
	{"[buttons second]\nwhen = v is 1\nUP = pause",
		"[buttons second]\nwhen = v\nUP = pause",
		"a comparison is missing"},
	{"[buttons third]\nUP = pause", "[buttons a b]\nUP = pause",
		"this kind of section has no name"},
	{"UP = attach head hand.R 0.3", "UP = attach head hat",
		"no node named hat"},
	{"UP = detach head", "UP = detach hat", "no part named hat"},
	{"UP = line \"two words\"", "UP = line \"two words",
		"quotation mark is missing"},
	{"UP = output led 50", "UP = output led blink", "write output NAME on"},
	{"UP = output led on, output led off", "UP = output lamp on",
		"no output named lamp"},
	{"UP = camera turn 60", "UP = camera pan 60",
		"camera turn|tilt|zoom NUMBER"},
	{"UP hold = set v 1", "UP hold = jump high", "jump is no action"},
	{"UP hold = add v 1, on wave, off wave, stop nod",
		"UP hold = on wave, toggle v",
		"would run in every frame while the button is held"},
	{"UP = move head pitch 1, stop nod", "UP = move head pitch 1, line on",
		"would run in every frame while the button is held"},
	{"UP = next \"what\"", "UP = next \"what\" else", "else is too much"},
};

static const char behind_buttons[] =
	"[parameter v]\n[state a]\nclip = walk\n[layer wave]\nclip = wave\n"
	"[morph face]\n[output led]\nline = gpiochip0/18\n"
	"[part head]\npitch = 0 -20 20\n"
	"[sequence nod]\nstep = down 0.5, head pitch 10\n[buttons]\n";

static const struct statement face[] = {
	{"[expression a]\ntargets = smile 0.5, wink\n",
		"[expression a]\ntargets = grin\n",
		"no morph target named grin: there are"},
	{"[expression a]\nnode = Face\ntargets = 0 1\n", "[expression a]\n",
		"an expression mixes targets"},
	{"[morph a]\nkey = calm\nkey = glad, smile 0.8, wink 0.1\n",
		"[morph a]\nkey = calm, smile 80\n", "from -10 to 10"},
	{"[morph a]\ntime = 0.5\n", "[morph a]\ntime = soon\n",
		"seconds from 0 to 60"},
	{"[morph a]\nframes = 12\n", "[morph a]\nframes = 0\n",
		"from 1 to 10000"},
	{"[morph a]\ncurve = linear\n", "[morph a]\ncurve = round\n",
		"linear, sine METRES"},
	{"[morph a]\ncurve = sine 0.02\ndirection = 0 0 1\n",
		"[morph a]\ncurve = sine\n", "a word is missing"},
	{"[morph a]\ncurve = linear\ncurve = sine 0.02 1 0 0 1.5 \"across\"\n",
		"[morph a]\ncurve = sine 0.02 0 0 0 1.5\n",
		"axis must not be 0 0 0"},
	{"[morph a]\nneck = 0.1 0.15\nturn = 10\n",
		"[morph a]\nneck = 0.15 0.1\nturn = 10\n",
		"the second height has to be larger"},
	{"[parameter t]\nrange = -9 9\n[morph a]\nneck = 0.1 0.15\nturn = t\n",
		"[morph a]\nturn = 90\n", "degrees from -28 to 28"},
	{"[morph a]\nweight = 0.5\n", "[morph a]\nweight = 2\n", "from 0 to 1"},
	{"[morph a]\ncurve = table 0 0.2 1.1 1\n",
		"[morph a]\ncurve = table 0.2 1\n",
		"begin with 0 and end with 1"},
	{"[morph a]\ncurve = bezier 0.4 0 0.2 1.4\n",
		"[morph a]\ncurve = bezier 0.4 0 1.2 1\n",
		"with x1 and x2 from 0 to 1"},
};

static const struct statement arm[] = {
	{"[part Arm]\nheading = 0 -160 160 45\n",
		"[part Arm]\nheading = 0 160 -160\n",
		"the start has to lie between"},
	{"[part lower]\nnode = Forearm\npitch = 5\n",
		"[part lower]\npitch = 5\n", "no node named lower"},
	{"[part Arm]\norder = pitch bank heading\nfirst = rotate\n",
		"[part Arm]\norder = pitch pitch heading\n", "once"},
	{"[part Arm]\nradius = 0.05\ntip = 0 0.5 0\n",
		"[part Arm]\ntip = 0.5\n", "a word is missing"},
	{"[part Car]\nz = 0\n[parameter roll]\nsource = part Car z 1023\n",
		"[part Car]\nz = 0\n[parameter roll]\nsource = part Car w\n",
		"w is not one of heading, pitch, bank, x, y and z"},
	{"[parameter p]\n[part Arm]\nbank = p\nx = 0 -1 1 0.5\ny = 0\nz = 0\n",
		"[part Arm]\nbank = p\n", "no parameter named p"},
	{"[part Arm]\npitch = 0\n[sequence a]\nstep = up 1, Arm pitch 30, Arm x 0.1\n",
		"[part Arm]\n[sequence a]\nstep = up, Arm pitch 30\n",
		"begins with its name and its seconds"},
	{"[part Crate]\n[sequence a]\nstep = up 1\nthen = attach Crate Hand, line up\nrepeat = yes\nstart = yes\n",
		"[part Crate]\n[sequence a]\nthen = attach Crate Hand\n",
		"there is no step before it"},
	{"[part Arm]\ntop = 0.1 -0.2 -0.3 0.2 0.3\n",
		"[part Arm]\ntop = 0.1 0.2 -0.3 -0.2 0.3\n",
		"the larger x and z"},
	{"[part Arm]\ntop = 0 0 0 1 1\ntop = 1 0 0 1 1\n",
		"[part Arm]\ntop = 0 0 0 1 1\ntop = 1 0 0 1 1\ntop = 2 0 0 1 1\n"
		"top = 3 0 0 1 1\ntop = 4 0 0 1 1\n",
		"at most 4 tops"},
	{"[part Arm]\nguard = 0.05 0 0.1 0 0 0.5 0\nguard = 0.1\n",
		"[part Arm]\nguard = 0.05 0 0.1\n", "a word is missing"},
	{"[part Arm]\npitch = 0 -20 20\n[sequence a]\nstep = up 1, Arm pitch 20\n",
		"[part Arm]\npitch = 0 -20 20\n[sequence a]\nstep = up 1, Arm pitch 21\n",
		"21 is outside of the part's limits -20 to 20"},
	{"[part Hand]\n[buttons]\nUP = attach Hand Car\n",
		"[part Arm]\n[buttons]\nUP = attach Arm Hand\n",
		"Hand moves with the part Arm"},
	{"[part Crate]\n[parameter near]\n[trigger grip]\nwhen = near > 0.5\nthen = attach Crate Hand 0.1 0 0 0.275\nelse = drop Crate Car\n",
		"[trigger grip]\nthen = pause\n", "a line is missing: add when"},
	{"[parameter p]\nchoices = arm hand\n[trigger t]\nwhen = p is hand\nelse = set p arm\n",
		"[parameter p]\nchoices = arm hand\n[trigger t]\nwhen = p is foot\n",
		"no parameter named foot"},
	{"[parameter p]\nchoices = arm, \"left hand\"\n[trigger t]\nwhen = p is \"left hand\"\nthen = line left\n",
		"[parameter p]\nchoices = arm\n", "one name is no choice"},
	{"[part Arm]\npitch = 0\n[sequence a]\nstep = up 1, Arm pitch 3\n",
		"[part Arm]\npitch = 0\n[sequence a]\nstep = up 1, Arm pitch\n",
		"give PART FREEDOM VALUE"},
};

static void check_all(const char *model, const char *before,
	const struct statement *statement, size_t count)
{
	struct acting acting;

	acting_begin(&acting, model);
	for (size_t i = 0; i < count; i++) {
		char text[1024];

		snprintf(text, sizeof(text), "%s%s\n", before,
			statement[i].right);
		acting_expect(&acting, text);
		acting_run_to(&acting, 0.5, 20.0);
		snprintf(text, sizeof(text), "%s%s\n", before,
			statement[i].wrong);
		acting_read(&acting, text);
		if (acting.error != -EINVAL || acting.logged.count != 1) {
			fail_msg("accepted: %s", statement[i].wrong);
		}
		assert_contains(acting.logged.sentence[0], "test.character:");
		assert_contains(acting.logged.sentence[0], statement[i].why);
	}
	acting_end(&acting);
}

static void test_statements_about_a_skeleton(void **state)
{
	(void)state;
	check_all("assets/walker.glb", "", walker, ARRAY_COUNT(walker));
}

static void test_statements_about_buttons(void **state)
{
	(void)state;
	check_all("assets/walker.glb", behind_buttons, buttons,
		ARRAY_COUNT(buttons));
}

static void test_statements_about_morphs(void **state)
{
	(void)state;
	check_all("assets/face.glb", "", face, ARRAY_COUNT(face));
}

static void test_statements_about_parts(void **state)
{
	(void)state;
	check_all("assets/arm.glb", "", arm, ARRAY_COUNT(arm));
}

static void test_an_error_names_file_line_section_and_key(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_read(&acting,
		"; a comment\n[state go]\nclip = walk\n  fade = soon\n");
	assert_string_equal(acting.logged.sentence[0],
		"test.character:4: [state go] fade: soon is not right here: give 0.3 or 4 frames, and smooth, linear or cubic");
	acting_end(&acting);
}

/* As a blank is part of the name, it stands in quotes everywhere. */
static void test_a_value_may_be_a_parameter_whose_name_has_blanks(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter \"my speed\"]\nrange = 0 9\nstart = 3\n"
		"[state a]\nclip = walk\nrate = \"my speed\"\n"
		"[state b]\nclip = run\n"
		"[transition a b]\nwhen = \"my speed\" > 2\n");
	assert_near(*acting.character->machine.state[0].rate, 3.0, 0.0);
	acting_run_to(&acting, 0.1, 20.0);
	assert_string_equal(acting_state(&acting), "b");
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_statements_about_a_skeleton),
		cmocka_unit_test(test_statements_about_buttons),
		cmocka_unit_test(test_statements_about_morphs),
		cmocka_unit_test(test_statements_about_parts),
		cmocka_unit_test(test_an_error_names_file_line_section_and_key),
		cmocka_unit_test(
			test_a_value_may_be_a_parameter_whose_name_has_blanks),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
