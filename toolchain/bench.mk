# make bench and make bench-arm11 measure the vertex loops on this machine, and
# loops, poses and frames on the timing model (tests/bench/README.md).

# Loops over vertices and pixels get the compiler's highest optimization.
build/arm/obj/app/anim/kernel/%.o: CFLAGS_arm += -O3
build/host/obj/app/anim/kernel/%.o \
build/host/obj/app/compare/candidate/fit.o: CFLAGS_host += -O3
build/arm/obj/app/scene/instance/%.o build/arm/obj/platform/gl/soft/%.o: \
	CFLAGS_arm += -O3
# Checks of the stack would cost frames on the board up to 1.6% of their
# instructions. These folders work on what loaders have checked.
build/arm/obj/app/anim/%.o build/arm/obj/app/scene/instance/%.o \
		build/arm/obj/platform/gl/soft/%.o: \
	CFLAGS_arm += -fno-stack-protector

BENCH_ARM := $(patsubst %,build/arm/bench/%,arm11 pose_cost play_cost \
	gl_scenes gl_states gl_costs calls/gl_calls demo_frames character_cost)
# Models whose rows of limber compare are played, with their clips.
PLAY_CHECK = python3 -B tests/bench/play_check.py build/host/limber \
	build/arm/bench/play_cost build/arm1136/model.so build/sysroot
PLAY_MODELS = assets/walker.glb@walk assets/face.glb@cycle \
	build/bench-models/tail.glb \
	--alone assets/walker.glb@jump build/bench-models/shapes.glb@talk \
	$(patsubst %,build/bench-models/%.glb,vanes pipe bird snake)
PLAY_SAMPLES = $(wildcard $(addprefix $(SAMPLES)/models/,CesiumMan.glb \
	RiggedFigure.glb BoxAnimated.glb AnimatedMorphCube.glb))
# Models whose pictures show what drawing costs; others can be given. Those of
# user_models.py are at rest, but the pipe stands in its clip, too.
DRAW_MODELS = assets/walker.glb@walk assets/walker.glb@jump assets/face.glb@cycle \
	assets/arm.glb@- $(addprefix $(SAMPLES)/models/,CesiumMan.glb \
	RiggedFigure.glb BoxAnimated.glb AnimatedMorphCube.glb RiggedSimple.glb \
	x/anim_test.x) \
	build/bench-models/pipe.glb@0 $(addsuffix @-,$(filter-out %/tail.glb \
	%/snake.glb %/shapes.glb %/vanes.glb,$(BENCH_MODELS)))
BENCH_FIGURES := tests/bench/arm11.figures
BENCH = tests/bench/arm11.py --samples $(SAMPLES)

build/arm/bench/%: build/arm/obj/tests/bench/%.o \
		build/arm/obj/tests/bench/bench_picture.o \
		build/arm/obj/tests/bench/states_mesh.o build/arm/liblimber.a \
		| build/test-packages.stamp
	@mkdir -p $(@D)
	$(call say,LINK,$@)
	$(Q)$(CC_arm) $(CFLAGS_arm) -o $@ $^ @build/arm/libs $(LIBS_arm)

build/host/bench/%: build/host/obj/tests/bench/%.o \
		build/host/obj/tests/bench/bench_picture.o \
		build/host/obj/tests/bench/states_mesh.o build/host/liblimber.a
	@mkdir -p $(@D)
	$(call say,LINK,$@)
	$(Q)$(CC_host) $(CFLAGS_host) -o $@ $^ @build/host/libs $(LIBS_host)

# This plugin counts instructions alone, several times as fast as the model.
build/arm1136/insn_count.so: tests/arm1136/insn_count.c | build/host/packages.stamp
	@mkdir -p $(@D)
	$(call say,CC,$@)
	$(Q)$(CC_host) $(COMMON_CFLAGS) -O2 -fPIC -shared -o $@ $<

# Models as users have them.
BENCH_MODELS := $(patsubst %,build/bench-models/%.glb,box duck duck-two-sided \
	colors cards layers banner glass leaves shells stone crate facets panes rope \
	blocks prism signs bush gem mosaic worm tail snake shapes hair rags dice \
	net tiles mirrors poster bricks blocky paper beads petals lamp \
	tower shoal yard tube drums mast pipe plate speck bird vanes parasol house sail)
$(BENCH_MODELS) &: $(wildcard tests/bench/models/*.py)
	$(call say,GEN,build/bench-models)
	$(Q)python3 -B tests/bench/models/user_models.py build/bench-models

.PHONY: bench-gl
bench-gl: build/host/bench/gl_states build/host/bench/demo_frames $(BENCH_MODELS)
	$(Q)tests/bench/gl_host.py build/host/bench build/bench-models

.PHONY: bench-costs
bench-costs: build/arm/bench/gl_costs build/arm1136/insn_count.so
	$(Q)tests/bench/gl_costs.py build/sysroot build/arm1136/insn_count.so $<

.PHONY: bench bench-arm11 bench-arm11-record bench-arm11-table
bench: build/host/limber
	$(Q)$< bench
# OSMESA=0 leaves out Debian's OSMesa, which takes longest.
OSMESA ?= 1
bench-arm11: $(BENCH_ARM) $(BENCH_MODELS) build/arm1136/model.so build/arm1136/insn_count.so
	$(Q)$(BENCH) --json build/bench-arm11.json $(if $(filter 1,$(OSMESA)),--osmesa)
	@echo "The same for programs: build/bench-arm11.json"
# To be run after a loop got better, or worse for a good reason.
bench-arm11-record: $(BENCH_ARM) $(BENCH_MODELS) build/arm1136/model.so
	$(Q)$(BENCH) --short --record $(BENCH_FIGURES)
	$(Q)$(MAKE) --no-print-directory bench-arm11-table
# Copies figures into the table that limber compare predicts with.
bench-arm11-table:
	$(Q)python3 -B tests/bench/arm11_table.py $(BENCH_FIGURES) \
		app/anim/kernel/arm11_cost.c

# Fits what drawing costs to pictures, and writes the table.
.PHONY: bench-draw-fit
bench-draw-fit: build/host/limber build/arm/bench/play_cost \
		build/arm1136/model.so $(BENCH_MODELS)
	$(Q)python3 -B tests/bench/draw_fit.py build/host/limber \
		build/arm/bench/play_cost build/arm1136/model.so build/sysroot \
		app/compare/cost/board_cost_draw.c $(DRAW_MODELS)

bench_suites = $(call suite,bench/arm11,$(BENCH) --short --check \
	$(BENCH_FIGURES)) \
	$(call suite,bench/checker,tests/bench/checker.sh $(BENCH_FIGURES)) \
	$(call suite,bench/play,$(PLAY_CHECK) $(PLAY_MODELS)) \
	$(call suite,bench/play-samples,$(PLAY_CHECK) $(PLAY_SAMPLES))
