# --version prints the version.
args --version

-- stdout --
smc [..]
