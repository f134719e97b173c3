# make demo shows the demos in a window or draws them as pictures; make assets
# makes the models again from their scripts, with levels of detail (assets/lod);
# make screenshots draws the pictures of README pages. Models are made in
# build/blender, because limber would find and load a folder build/assets.

demo: build/host/limber
	$(Q)toolchain/demo.sh build/host/limber build/demo

# Most of the pictures are references of the tests, which make golden draws;
# board.mk draws the virtual PDK's page.
.PHONY: screenshots-program
screenshots: golden screenshots-program
screenshots-program: build/host/limber
	$(call say,PICTURE,assets/pictures)
	$(Q)$(CHECK_ENVIRONMENT) toolchain/screenshots.sh $< assets/pictures \
		app/compare/example.md

# Each model in assets/ has a script of the same name.
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

# Makes the levels of detail again, without Blender.
.PHONY: assets-lod
assets-lod: build/lod/stamp
	$(Q)node build/lod/lod.mjs $(MODELS:%=assets/%.glb)

# The scripts are copied beside the package, where node searches for it.
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
