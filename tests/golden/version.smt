# --version prints the version.
args --version

-- stdout --
smc 0.1.0
