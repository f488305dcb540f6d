"""zstd, by the library itself."""

import ctypes

LIBRARY = ctypes.CDLL("libzstd.so.1")
LIBRARY.ZSTD_createDCtx.restype = ctypes.c_void_p
LIBRARY.ZSTD_decompress_usingDict.restype = ctypes.c_size_t
CONTEXT = ctypes.c_void_p(LIBRARY.ZSTD_createDCtx())
LARGEST = 1 << 30


def zstd_content(data, size=None, dictionary=b""):
    """The content of one zstd frame, of `size` bytes if that is known."""
    capacity = size or 1 << 12
    while capacity <= LARGEST:
        content = ctypes.create_string_buffer(capacity)
        written = LIBRARY.ZSTD_decompress_usingDict(
            CONTEXT,
            content,
            ctypes.c_size_t(capacity),
            data,
            ctypes.c_size_t(len(data)),
            dictionary,
            ctypes.c_size_t(len(dictionary)),
        )
        if not LIBRARY.ZSTD_isError(ctypes.c_size_t(written)):
            if size is not None and written != size:
                raise ValueError("a zstd frame has another size than expected")
            return content.raw[:written]
        if size is not None:
            break
        capacity *= 2
    raise ValueError("this is no zstd frame")
