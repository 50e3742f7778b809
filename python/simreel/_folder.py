"""Temporary folders that live as long as an object."""
import shutil
import tempfile
import weakref


def folder_of(owner, prefix):
    """Returns a new folder, which is removed together with its owner."""
    folder = tempfile.mkdtemp(prefix=f"simreel-{prefix}-")
    weakref.finalize(owner, shutil.rmtree, folder, True)
    return folder
