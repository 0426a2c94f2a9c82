"""Reports of the experiments: the C++ tools measure, these modules tabulate and draw."""
