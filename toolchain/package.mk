# make install installs limber on this machine; make deb makes a package of it, and
# make bundle an archive for boards.

prefix ?= /usr/local
DESTDIR ?=
INSTALLED := $(DESTDIR)$(prefix)
PACKAGE := toolchain/package
ASSET_FILES := $(sort $(wildcard assets/*.glb assets/*.character)) \
	assets/presets.ini
CHARACTER_FILES := $(sort $(wildcard assets/characters/*.character))

build/host/limber.1: build/host/limber $(PACKAGE)/man.sh \
		$(PACKAGE)/man_page.awk app/character/format.md
	$(call say,MAN,$@)
	$(Q)$(PACKAGE)/man.sh build/host/limber >$@

.PHONY: install uninstall deb
install: build/host/limber build/host/limber.1
	$(call say,INSTALL,$(INSTALLED))
	$(Q)install -D -m 755 build/host/limber $(INSTALLED)/bin/limber
	$(Q)install -d $(INSTALLED)/share/limber
	$(Q)install -m 644 $(ASSET_FILES) $(INSTALLED)/share/limber
	$(Q)install -d $(INSTALLED)/share/limber/characters
	$(Q)install -m 644 $(CHARACTER_FILES) \
		$(INSTALLED)/share/limber/characters
	$(Q)install -D -m 644 build/host/limber.1 \
		$(INSTALLED)/share/man/man1/limber.1
	$(Q)install -D -m 644 $(PACKAGE)/limber.bash \
		$(INSTALLED)/share/bash-completion/completions/limber
	$(Q)install -D -m 644 $(PACKAGE)/limber.desktop \
		$(INSTALLED)/share/applications/limber.desktop
	$(Q)install -D -m 644 $(PACKAGE)/limber.svg \
		$(INSTALLED)/share/icons/hicolor/scalable/apps/limber.svg
	$(Q)install -D -m 644 LICENSE $(INSTALLED)/share/doc/limber/copyright

uninstall:
	$(Q)rm -rf $(INSTALLED)/share/limber $(INSTALLED)/share/doc/limber
	$(Q)rm -f $(INSTALLED)/bin/limber $(INSTALLED)/share/man/man1/limber.1 \
		$(INSTALLED)/share/bash-completion/completions/limber \
		$(INSTALLED)/share/applications/limber.desktop \
		$(INSTALLED)/share/icons/hicolor/scalable/apps/limber.svg

build/package/packages.stamp: toolchain/packages/package.txt
	$(Q)mkdir -p $(@D)
	$(Q)toolchain/install.sh package
	$(Q)touch $@

deb: build/host/limber build/package/packages.stamp
	$(Q)rm -rf build/package/stage
	$(Q)$(MAKE) --no-print-directory install DESTDIR=build/package/stage \
		prefix=/usr
	$(Q)$(PACKAGE)/deb.sh build/package/stage build/package

# Phony, because bundle.py takes two seconds.
.PHONY: bundle
bundle: build/arm/limber build/host/limber
	$(Q)python3 -B $(PACKAGE)/bundle.py build/sysroot build/arm/limber build/host/limber \
		build/package
