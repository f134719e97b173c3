# make demo, make assets.
