"""Make toast.

Said with: toast.
"""


def make_toast():
    # grab the bread
    grab('breadslice | bread | toast')
    # toast it
    put('breadslice | bread | toast', 'toaster')
    switchon('toaster')
