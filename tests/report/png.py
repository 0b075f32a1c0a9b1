# SPDX-License-Identifier: Apache-2.0
# png.py FILE WIDTH HEIGHT: whether FILE is a PNG of that size, whole, with a page on it: its pixels are there and not all lines are alike.
import struct
import sys
import zlib

data = open(sys.argv[1], "rb").read()
if data[:8] != b"\x89PNG\r\n\x1a\n":
    sys.exit("it does not begin as a PNG")
at, pixels, size, ended = 8, b"", None, False
while at + 12 <= len(data) and not ended:
    length, kind = struct.unpack(">I4s", data[at:at + 8])
    body = data[at + 8:at + 8 + length]
    if zlib.crc32(kind + body) != struct.unpack(">I", data[at + 8 + length:at + 12 + length])[0]:
        sys.exit("a checksum is wrong")
    if kind == b"IHDR":
        size = struct.unpack(">IIBB", body[:10])
    elif kind == b"IDAT":
        pixels += body
    ended = kind == b"IEND"
    at += 12 + length
if not ended or size is None or list(size[:2]) != [int(n) for n in sys.argv[2:4]]:
    sys.exit("it is of the size %s, or not whole" % (size,))
pixels = zlib.decompress(pixels)
line = 1 + size[0] * size[2] // 8 * {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}[size[3]]
if len(pixels) != line * size[1]:
    sys.exit("pixels are missing")
if len({pixels[i:i + line] for i in range(0, len(pixels), line)}) < 100:
    sys.exit("there is next to nothing on it")
