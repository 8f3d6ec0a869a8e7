"""PNG pictures, read with Python's standard library: 8 bits, RGB or RGBA, not interlaced."""
import struct
import zlib


def read(data):
    """Width, height and rows of (r, g, b) as bytes."""
    assert data[:8] == b"\x89PNG\r\n\x1a\n", "no PNG"
    at, packed = 8, b""
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(">IIBBBBB", body)
            assert depth == 8 and colour in (2, 6) and not interlaced
        packed += body if kind == b"IDAT" else b""
        at += 12 + size
    channels = 3 if colour == 2 else 4
    raw, stride, before, rows = zlib.decompress(packed), width * channels, bytes(width * channels), []
    for y in range(height):
        line = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        unfilter(raw[y * (stride + 1)], line, before, channels)
        before = line
        rows.append(line if channels == 3 else b"".join(line[i:i + 3] for i in range(0, stride, 4)))
    return width, height, rows


def unfilter(kind, line, before, channels):
    for i in range(len(line)):
        left = line[i - channels] if i >= channels else 0
        above = before[i]
        if kind == 1:
            line[i] = line[i] + left & 255
        elif kind == 2:
            line[i] = line[i] + above & 255
        elif kind == 3:
            line[i] = line[i] + (left + above) // 2 & 255
        elif kind == 4:
            corner = before[i - channels] if i >= channels else 0
            guess = left + above - corner
            distances = abs(guess - left), abs(guess - above), abs(guess - corner)
            line[i] = line[i] + (left, above, corner)[distances.index(min(distances))] & 255


def difference(one, other):
    """Root mean square of all channels, share of pixels with a channel that differs by more than 8, and the
    greatest difference [level of 255]."""
    (width, height, rows), (w, h, others) = read(one), read(other)
    assert (width, height) == (w, h), f"{width}x{height} is not {w}x{h}"
    squares, beyond, most = 0, 0, 0
    for a, b in zip(rows, others):
        if a == b:
            continue
        apart = [abs(x - y) for x, y in zip(a, b)]
        squares += sum(d * d for d in apart)
        most = max(most, *apart)
        beyond += sum(max(apart[i:i + 3]) > 8 for i in range(0, len(apart), 3))
    return (squares / (3 * width * height)) ** 0.5, beyond / (width * height), most
