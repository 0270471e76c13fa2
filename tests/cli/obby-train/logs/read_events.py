# Prints the scalars of a TensorBoard events file, one per line: step, tag, value. The code
# follows the specifications of the formats (TFRecord framing, CRC-32C and Protocol Buffers), not
# our writer.
import struct
import sys


def crc32c(data):
    crc = 0xFFFFFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0x82F63B78 if crc & 1 else 0)
    return crc ^ 0xFFFFFFFF


def masked(data):
    crc = crc32c(data)
    return ((crc >> 15 | crc << 17) + 0xA282EAD8) & 0xFFFFFFFF


def records(data):
    at = 0
    while at < len(data):
        (length,) = struct.unpack_from("<Q", data, at)
        assert struct.unpack_from("<I", data, at + 8)[0] == masked(data[at : at + 8]), "length"
        body = data[at + 12 : at + 12 + length]
        assert struct.unpack_from("<I", data, at + 12 + length)[0] == masked(body), "body"
        yield body
        at += length + 16


def varint(data, at):
    value = shift = 0
    while True:
        value |= (data[at] & 0x7F) << shift
        shift, at = shift + 7, at + 1
        if data[at - 1] < 0x80:
            return value, at


def fields(data):
    at, out = 0, []
    while at < len(data):
        key, at = varint(data, at)
        kind = key & 7
        if kind == 0:
            value, at = varint(data, at)
        else:
            length, at = varint(data, at) if kind == 2 else ({1: 8, 5: 4}[kind], at)
            value, at = data[at : at + length], at + length
        out.append((key >> 3, value))
    return out


for name in sys.argv[1:]:
    for record in records(open(name, "rb").read()):
        event = dict(fields(record))
        assert struct.unpack("<d", event[1])[0] > 1.6e9, "wall time"
        step = event.get(2, 0)
        if 3 in event:
            print(step, "version", event[3].decode())
        if 7 in event:
            print(step, "session", dict(fields(event[7])))
        for number, value in fields(event.get(5, b"")):
            scalar = dict(fields(value))
            print(step, scalar[1].decode(), "%.6g" % struct.unpack("<f", scalar[2])[0])
