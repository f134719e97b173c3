# Not build/assets: the program looks for assets/ in the folders above itself.
# make demo: the demos in a window, or as pictures. make assets: the models
# again from their scripts, with coarser levels (assets/lod). make screenshots:
# the pictures of README pages.

demo: build/host/limber
	$(Q)toolchain/demo.sh build/host/limber build/demo

# Most of the pictures are references of the tests, which make golden draws; the
# virtual PDK's page is board.mk's.
.PHONY: screenshots-program
screenshots: golden screenshots-program
screenshots-program: build/host/limber
	$(call say,PICTURE,assets/pictures)
	$(Q)$(CHECK_ENVIRONMENT) toolchain/screenshots.sh $< assets/pictures \
		README.md

# Every model here has a script of the same name.
MODELS := $(patsubst assets/%.glb,%,$(sort $(wildcard assets/*.glb)))

.PHONY: $(MODELS:%=assets-%)
assets: $(MODELS:%=assets-%)
$(MODELS:%=assets-%): assets-%: build/blender/packages.stamp build/lod/stamp
	$(call say,BLENDER,assets/$*.glb)
	$(Q)blender -b --factory-startup --python-exit-code 1 \
		-P assets/$*.py -- build/blender/$*.glb \
		>build/blender/$*.log 2>&1 || \
		{ cat build/blender/$*.log >&2; exit 1; }
	$(call say,LOD,assets/$*.glb)
	$(Q)node build/lod/lod.mjs build/blender/$*.glb >build/blender/$*.lod
	$(Q)cp build/blender/$*.glb assets/$*.glb

# The models as they are with levels made again, without Blender.
.PHONY: assets-lod
assets-lod: build/lod/stamp
	$(Q)node build/lod/lod.mjs $(MODELS:%=assets/%.glb)

# The scripts lie beside the package, where node looks for it.
build/lod/stamp: $(wildcard assets/lod/*.mjs) $(addprefix assets/lod/, \
		package.json package-lock.json .npmrc) build/blender/packages.stamp
	@mkdir -p $(@D)
	$(call say,NPM,$(@D))
	$(Q)cp $(filter assets/lod/%,$^) $(@D)
	$(Q)cd $(@D) && npm ci --loglevel=error --no-audit --no-fund >npm.log
	$(Q)touch $@

build/blender/packages.stamp: toolchain/packages/assets.txt
	$(Q)mkdir -p $(@D)
	$(Q)toolchain/install.sh assets
	$(Q)touch $@
